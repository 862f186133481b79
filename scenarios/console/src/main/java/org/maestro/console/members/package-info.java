/**
 * Members one by one, as people work with them: what one is at and can do now, and the calls of its
 * features that people make by hand. What the home describes, what the bus tells and what people
 * order flows in; documents flow out, and orders to agents. It knows no plans: a call by hand
 * serves no goal.
 */
@NullMarked
package org.maestro.console.members;

import org.jspecify.annotations.NullMarked;
