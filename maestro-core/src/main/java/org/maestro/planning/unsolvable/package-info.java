/**
 * Why a planning task of others has no plan: the condition that nothing brings about, or the parts
 * of the goal that exclude each other. A task that was proven to have none flows in, sentences flow
 * out; what is not proven is not said. It knows nothing of homes.
 */
@NullMarked
package org.maestro.planning.unsolvable;

import org.jspecify.annotations.NullMarked;
