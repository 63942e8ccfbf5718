/* SPDX-License-Identifier: Apache-2.0
   Leaves the picture as it is. */
imager null()
{
}
