/**
 * The carrying out of action scripts (ADE, 4.1 and 5): a body is gone through part by part, each
 * part that acts is a goal of its own, planned over all devices or one call of one member. A
 * script, values for its parameters, changes of knowledge and ends of these goals flow in; goals to
 * be begun, notes for the journal and sentences flow out. What was noted is not done again after a
 * restart. It knows nothing of how a goal is planned.
 */
@NullMarked
package org.maestro.coordination.scripts;

import org.jspecify.annotations.NullMarked;
