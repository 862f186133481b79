/**
 * The faces of a home, for pages that draw them. What members that are faces tell of themselves on
 * the bus flows in as it is told; documents of it flow out. It knows neither the words of that nor
 * how a face is drawn.
 */
@NullMarked
package org.maestro.console.faces;

import org.jspecify.annotations.NullMarked;
