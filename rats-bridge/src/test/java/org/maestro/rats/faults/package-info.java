/** What the bus and its members do when something breaks, with the figures that they must keep. */
package org.maestro.rats.faults;
