/**
 * Messages between platforms, by FIPA's HTTP transport. JADE's own transport carries them; here is
 * what it needs on a Java of today, and what is asked of an envelope before anybody believes it.
 * The text of an envelope flows in, what it says flows out. It may not know what messages say.
 */
@NullMarked
package org.maestro.platform.letters;

import org.jspecify.annotations.NullMarked;
