/**
 * Publish and subscribe over MQTT 5 (Paho, hidden here) or within the process, behind one interface
 * and under the same contract tests. Topics and bytes flow both ways. It may not know what the
 * bytes mean.
 */
@NullMarked
package org.maestro.rats.transport;

import org.jspecify.annotations.NullMarked;
