/**
 * Statements kept beyond a restart, on disk or in the dataset. Statements flow in; those not too
 * old flow out, a damaged line is left out and said. What counts now is not its business.
 */
@NullMarked
package org.maestro.knowledge.history;

import org.jspecify.annotations.NullMarked;
