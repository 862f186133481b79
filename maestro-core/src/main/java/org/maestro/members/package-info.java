/**
 * What stands between the heart and one member on the bus, whoever speaks for the member: what it
 * said of itself, what its calls report and teach, and its values as terms. Events of the link flow
 * in; reports, lessons and facts flow out. Plain Java: agents and sites without agents share it.
 */
@NullMarked
package org.maestro.members;

import org.jspecify.annotations.NullMarked;
