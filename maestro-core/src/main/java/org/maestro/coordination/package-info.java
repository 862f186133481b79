/**
 * The way of a goal (paper section 3.3): life cycle, contract net, allocation, execution in partial
 * order, repair, confirmation and the story of it all. Goals, bids, reports and changes of
 * knowledge flow in; calls for prices, awards, orders and stories flow out through ports. Plain
 * Java that a unit test drives: it knows neither JADE nor the bus nor any word of a domain.
 */
package org.maestro.coordination;
