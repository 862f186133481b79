/** What the guides show, as tests: the examples of devices, and the commands. */
package org.maestro.guide;
