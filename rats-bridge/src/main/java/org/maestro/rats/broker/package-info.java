/**
 * The embedded MQTT 5 broker (Artemis without journal), on loopback and a free port unless told
 * otherwise. A port flows out; it may not know the protocol spoken over it.
 */
@NullMarked
package org.maestro.rats.broker;

import org.jspecify.annotations.NullMarked;
