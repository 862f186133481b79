/**
 * Goals beside each other: what steps of one would spoil for another, leases on what all of them
 * want, and who waits for whom (ADE, 4.1; A55). Steps and plans flow in; what may begin, and who is
 * woken, flow out. It sees goals only as they see each other, not how they are reached.
 */
@NullMarked
package org.maestro.coordination.contention;

import org.jspecify.annotations.NullMarked;
