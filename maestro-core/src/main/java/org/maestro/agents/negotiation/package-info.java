/**
 * The FIPA contract net and orders over ACL (Three-layered architecture, 3.3.3; M76): calls for
 * proposals, contracts, orders and their reports. Calls for prices and orders of the coordination
 * flow in; bids, and the reason of each silence and refusal, flow out. It knows no plan.
 */
@NullMarked
package org.maestro.agents.negotiation;

import org.jspecify.annotations.NullMarked;
