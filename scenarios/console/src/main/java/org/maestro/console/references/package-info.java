/**
 * What the running parts of a platform are for, and which of them refers to which. The agents that
 * there are, the home as it is now and what is known flow in; components and references flow out,
 * as a document. It asks nobody, and draws nothing.
 */
@NullMarked
package org.maestro.console.references;

import org.jspecify.annotations.NullMarked;
