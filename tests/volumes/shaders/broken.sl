// SPDX-License-Identifier: Apache-2.0
volume broken() { Ci = Ci / (u - u); }
