package org.maestro.platform.jade;

import jade.core.Profile;
import jade.util.leap.Properties;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import org.maestro.agents.device.Host;
import org.maestro.agents.device.HostService;
import org.maestro.agents.pulse.ProcessPulse;
import org.maestro.agents.pulse.PulseService;
import org.maestro.agents.stepping.SteppedMailService;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.guard.GuardedProfile;
import org.maestro.platform.guard.HomeMobilityService;
import org.maestro.platform.guard.SerialFilter;
import org.maestro.platform.letters.BoundedLetters;
import org.maestro.platform.letters.EnvelopeReader;
import org.maestro.platform.threads.AgentThreads;
import org.maestro.platform.wires.CuttablePeer;

/**
 * The properties of a JADE container that is to be made, with safe defaults: loopback only, no
 * multicast, no MTP, no files in the working directory.
 */
final class ContainerProfile {
  private static final String LETTERS = BoundedLetters.class.getName();
  private static final String SERVICES =
      String.join(
          ";",
          HomeMobilityService.class.getName(),
          "jade.core.event.NotificationService",
          MailWitnessService.class.getName(),
          SteppedMailService.class.getName(),
          PulseService.class.getName(),
          HostService.class.getName());

  /** What listens for other containers. Where nothing is named JADE takes one that asks nobody. */
  private static final String PEERS = "icps";

  private static final String NONE = "";

  private ContainerProfile() {}

  /**
   * The first container of a platform in this process listens for others; those that follow are
   * reached there too, and open no door of their own.
   *
   * @param guard of a secured site; empty: whoever reaches the port may join
   */
  static void listen(Properties properties, Optional<Guard> guard, int port) {
    properties.setProperty(
        PEERS, guard.isPresent() ? GuardedProfile.peer() : CuttablePeer.class.getName());
    properties.setProperty(Profile.LOCAL_PORT, String.valueOf(port));
  }

  /** Agents of other platforms are heard. */
  static void exchange(Properties properties, Premises.LetterBox box) {
    properties.setProperty(Profile.NO_MTP, "false");
    properties.setProperty(Profile.MTPS, LETTERS + "(" + box.url() + ")");
    properties.setProperty("jade_mtp_http_parser", EnvelopeReader.class.getName());
  }

  /** What all containers have in common; what is sent to them is read with care from now on. */
  static Properties common(Path fileDirectory, Host host, String from, SharedParts shared) {
    SerialFilter.install();
    Properties properties = new Properties();
    properties.put(ProcessPulse.KEY, shared.pulse());
    properties.put(MailWitness.KEY, shared.mail());
    properties.put(HostService.KEY, host);
    properties.setProperty(Profile.LOCAL_HOST, from);
    properties.setProperty(Profile.DETECT_MAIN, "false");
    properties.setProperty(Profile.NO_MTP, "true");
    properties.setProperty(Profile.SERVICES, SERVICES);
    properties.setProperty(Profile.FILE_DIR, fileDirectory + File.separator);
    properties.setProperty(PEERS, NONE);
    properties.setProperty("jade_imtp_leap_JICP_JICPServer_acceptlocalhostonly", "true");
    properties.setProperty("jade_imtp_leap_JICP_JICPServer_acceptmediators", "false");
    properties.setProperty("jade_core_messaging_MessageManager_poolsize", "1");
    properties.setProperty("jade_domain_df_autocleanup", "true");
    AgentThreads.chosen().choose(properties);
    return properties;
  }
}
