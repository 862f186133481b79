/**
 * The connections between the containers of a platform, so that those to a container that has been
 * given up can be cut. JADE waits for a frozen process for ever, with all that is to be sent after
 * it; once the connections are cut it takes the process for killed, which it knows how to treat.
 * What others connect is heard once the main container is ready, and let go where it says nothing.
 * An address flows in; broken connections flow out. It may not know who has been given up, and why.
 */
@NullMarked
package org.maestro.platform.wires;

import org.jspecify.annotations.NullMarked;
