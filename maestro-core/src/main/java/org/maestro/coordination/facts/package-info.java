/**
 * What is known, asked for one goal: which facts it counts on, which of them must be seen, what
 * holds beside or after steps that run. Snapshots, conditions and steps flow in; facts, interests
 * and looks that are due flow out. It decides nothing, and knows no goal's course.
 */
@NullMarked
package org.maestro.coordination.facts;

import org.jspecify.annotations.NullMarked;
