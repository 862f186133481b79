package org.maestro.rats.gateway;

import java.util.Optional;
import org.maestro.rats.protocol.CostAnswer;

/** The role of a gateway's lamps on the RATS bus: their ids, descriptions and words. */
public interface LampRole {

  /** The member's id; empty: this lamp does not take part. */
  Optional<String> id(ZigbeeLamp lamp);

  /** The JSON-LD document that the member publishes. */
  String description(String id, ZigbeeLamp lamp);

  /** The feature that sets the light. */
  String feature();

  /** Its parameter, the share of light from 0 to 1. */
  String parameter();

  /** The fact that tells the share of light, in MAESTRO-SL. */
  String fact(String id, double level);

  /**
   * The price of a change.
   *
   * @param now the share of light that the lamp gives, as far as known
   */
  CostAnswer cost(String id, Optional<Double> now, double level);
}
