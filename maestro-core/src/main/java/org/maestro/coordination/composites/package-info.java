/**
 * Scripts as steps of plans: those whose effect is stated take part in the planning of goals as one
 * more member, whose calls are the scripts carried out. Scripts of the home flow in; what planning
 * and plan following see of the world with them flows out. It knows neither how a script is carried
 * out nor for which goals plans are made.
 */
@NullMarked
package org.maestro.coordination.composites;

import org.jspecify.annotations.NullMarked;
