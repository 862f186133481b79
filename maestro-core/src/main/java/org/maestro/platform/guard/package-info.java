/**
 * Keeps strangers out of a secured site's platform: containers are let in over TLS by certificate
 * and join token, messages between agents carry their sender's signature, and what is deserialised
 * is filtered. A site's security files flow in; a guarded JADE flows out. It may not know what
 * agents say, and an open site uses nothing of it.
 */
package org.maestro.platform.guard;
