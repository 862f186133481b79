/**
 * Global planning over all devices (Three-layered architecture, 3.2.2; M55): the cheapest partially
 * ordered sequence of feature instances that reaches a goal from what is known, or the reason why
 * there is none. Facts, priced features and a goal flow in, a plan or an explanation flows out. It
 * knows neither agents, RDF nor any word of a domain.
 */
@NullMarked
package org.maestro.planning;

import org.jspecify.annotations.NullMarked;
