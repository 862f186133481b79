/**
 * Homes on a bad bus and a bad disk. A seed flows in; a home, its goals and a schedule of all kinds
 * of faults come of it, then what the history of the bus, the journal and the judge of claims have
 * found.
 */
@NullMarked
package org.maestro.chaos;

import org.jspecify.annotations.NullMarked;
