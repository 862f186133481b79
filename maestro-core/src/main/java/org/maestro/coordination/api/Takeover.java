package org.maestro.coordination.api;

/**
 * An offer to take over what another member is at (Three-layered architecture, 3.2.1; M43). Whether
 * it is taken is the goal's own decision, by a plan from the present.
 *
 * @param by who offers
 * @param from who is at it
 * @param feature which both have
 * @param cost what it would cost, from where the offering member is now
 * @param seconds how long it would take it
 */
public record Takeover(String by, String from, String feature, double cost, double seconds) {}
