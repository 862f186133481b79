/**
 * What the result of a feature teaches: its effect read as facts, checked against what the member
 * itself has reported. Results and the facts before flow in; claims flow out. It plans nothing.
 */
@NullMarked
package org.maestro.knowledge.learning;

import org.jspecify.annotations.NullMarked;
