/**
 * Keeps strangers out of a platform. On every site what is deserialised is filtered, and no code
 * comes in with an agent; on a secured one containers are let in over TLS by certificate and join
 * token, and messages between agents carry their sender's signature. A site's security files flow
 * in; a guarded JADE flows out. It may not know what agents say.
 */
@NullMarked
package org.maestro.platform.guard;

import org.jspecify.annotations.NullMarked;
