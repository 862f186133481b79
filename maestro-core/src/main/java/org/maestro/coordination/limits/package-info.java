/**
 * Goals of persons who may not have everything done: a goal's request and the ports flow in, ports
 * to the home as it is for that person flow out, or a goal that ends before anything is done for
 * it. In that home each limit is a condition of the feature, so that no plan, held goal or script
 * goes beyond it; what she may never have done nobody is asked for.
 */
@NullMarked
package org.maestro.coordination.limits;

import org.jspecify.annotations.NullMarked;
