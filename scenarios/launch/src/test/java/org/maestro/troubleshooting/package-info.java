/** {@code docs/troubleshooting.md}: every message of the code stands there, as the code has it. */
package org.maestro.troubleshooting;
