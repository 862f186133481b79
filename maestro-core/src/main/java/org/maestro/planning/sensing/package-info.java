/**
 * Plans over what nobody knows: how likely each place is, what looks cost, and where to look first
 * so that the whole goal is expected to cost least. A ground problem with unknowns flows in;
 * suppositions and an order of looks flow out.
 */
@NullMarked
package org.maestro.planning.sensing;

import org.jspecify.annotations.NullMarked;
