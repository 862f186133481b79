/**
 * How long a build's tests took: read from the reports of the modules before, and from this one's.
 */
package org.maestro.slowest;
