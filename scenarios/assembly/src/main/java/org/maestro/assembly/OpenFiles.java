package org.maestro.assembly;

import com.sun.management.UnixOperatingSystemMXBean;
import java.lang.management.ManagementFactory;

/** The limit on files and connections that this process may have open. */
public final class OpenFiles {

  /** What a process of a site opens besides: libraries loaded late, logs, the platform's ports. */
  private static final int BESIDES = 64;

  /** Connection and broker's end of it, what each polls, and one while it connects anew. */
  private static final int FOR_EACH_MEMBER = 6;

  private OpenFiles() {}

  /**
   * To be asked before a site is opened: who runs out of files while it opens says many things, and
   * not the cause.
   *
   * @param members that connect to the bus from here
   * @throws SiteException when they are too few for so many members
   */
  public static void requireFor(int members) {
    if (ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean system) {
      require(members, system.getOpenFileDescriptorCount(), system.getMaxFileDescriptorCount());
    }
  }

  static void require(int members, long open, long most) {
    long needed = open + BESIDES + (long) FOR_EACH_MEMBER * members;
    if (needed > most) {
      throw new SiteException(
          "Only %d files may be open at a time here, and %d devices need about %d; raise that: ulimit -n %d."
              .formatted(most, members, needed, Math.max(4096, 2 * needed)));
    }
  }
}
