/**
 * The console of a running platform: a server on loopback with a page for people and an API for
 * programs. Requests come in by HTTP and are answered by {@code questions} and by what is known;
 * events go out as they happen. It knows the platform from outside, as any client does, and of
 * devices only what the home and the agents tell.
 */
@NullMarked
package org.maestro.console;

import org.jspecify.annotations.NullMarked;
