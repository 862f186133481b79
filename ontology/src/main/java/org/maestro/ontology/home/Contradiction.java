package org.maestro.ontology.home;

import org.maestro.ontology.validation.Fault;

/**
 * Why a description that is right by itself cannot join what is there.
 *
 * @param problem read after the device's name
 * @param cure what would be right
 */
public record Contradiction(String problem, String cure) {

  /** It as a fault of the text that it was found in. */
  Fault fault(String source, String device) {
    return new Fault(source, 0, device, "", problem, cure);
  }

  /** One sentence about the device. */
  public String sentence(String device) {
    return "%s %s; %s.".formatted(device, problem, cure);
  }
}
