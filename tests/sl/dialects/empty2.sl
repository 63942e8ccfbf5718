/* SPDX-License-Identifier: Apache-2.0 */
displacement a(void)
{
}
