package org.maestro.platform.jade;

import org.maestro.agents.pulse.ProcessPulse;
import org.maestro.platform.wires.Wires;
import org.maestro.rats.time.HybridClock;

/**
 * The parts common to the containers that one platform has in this process.
 *
 * @param wires their connections to others
 * @param pulse their signs of life
 * @param mail the witness of their agents' messages
 */
public record SharedParts(Wires wires, ProcessPulse pulse, MailWitness mail) {

  /** For the first of them. */
  public static SharedParts fresh() {
    return new SharedParts(
        new Wires(), new ProcessPulse(), new MailWitness(HybridClock.ofProcess()));
  }
}
