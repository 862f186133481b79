/**
 * The RATS bus, version 1, as plain records and their JSON: calls, results, progress, status,
 * states, descriptions, topics, error codes. Bytes flow in and records out, and back. It knows
 * neither MQTT clients nor members; the JSON Schemas beside it are what its tests check.
 */
@NullMarked
package org.maestro.rats.protocol;

import org.jspecify.annotations.NullMarked;
