package org.maestro.platform.guard;

import jade.core.Profile;
import jade.util.leap.Properties;

/** The JADE properties by which a container is guarded. */
public final class GuardedProfile {
  private GuardedProfile() {}

  /** Has a container of this process signed and checked; to be called once for each. */
  public static void guard(Properties profile, Guard guard) {
    guard.writeTo(profile);
    String signed = SignedMailService.class.getName();
    String others = profile.getProperty(Profile.SERVICES, "");
    profile.setProperty(Profile.SERVICES, others.isEmpty() ? signed : others + ";" + signed);
  }

  /**
   * The class of what listens for other containers, and calls them, by TLS: for the first container
   * of a platform in a process only, the others use what it has opened.
   */
  public static String peer() {
    return GuardedPeer.class.getName();
  }
}
