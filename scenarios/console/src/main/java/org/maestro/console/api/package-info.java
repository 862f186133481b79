/**
 * The API as a table: each operation with its path, its parameters, the schema of what it takes and
 * answers, and what it does. From this table requests are answered, and the OpenAPI document is
 * made. It knows no server.
 */
@NullMarked
package org.maestro.console.api;

import org.jspecify.annotations.NullMarked;
