/**
 * The way of a goal (paper section 3.3): life cycle, contract net, allocation, execution in partial
 * order, repair, confirmation and the story of it all. Goals, bids, reports and changes of
 * knowledge flow in; calls for prices, awards, orders and stories flow out through ports. Here
 * stands the Coordinator, with which goal a request is, who is there, and what has ended; its parts
 * are in packages of their own, of which others see {@code api} and {@code journal}. Plain Java
 * that a unit test drives: it knows neither JADE nor the bus nor any word of a domain.
 */
@NullMarked
package org.maestro.coordination;

import org.jspecify.annotations.NullMarked;
