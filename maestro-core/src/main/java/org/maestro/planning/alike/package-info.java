/**
 * Members of which the very same is known: whom a plan can do with in each other's place. A task
 * flows in; the same task with few of them flows out, and what is found for it, told of all. It
 * does not know how plans are found.
 */
@NullMarked
package org.maestro.planning.alike;

import org.jspecify.annotations.NullMarked;
