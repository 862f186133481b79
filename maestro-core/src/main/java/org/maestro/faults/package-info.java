/** A file system that fails as disks do, to be given to whatever keeps something in files. */
package org.maestro.faults;
