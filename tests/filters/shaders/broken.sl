/* SPDX-License-Identifier: Apache-2.0 */
filter broken()
{
    setimage("Ci", 0, 0, nothing);
}
