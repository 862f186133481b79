package org.maestro.rats.conformance;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;

/** A call that was made, and what came of it. */
record Made(Map<String, Object> call, Optional<JsonNode> result, Duration took) {

  /** After so much of the usual time it is clear that nothing ended it. */
  private static final double MOST_OF_IT = 0.75;

  String outcome() {
    return result.isEmpty() ? "not answered" : Dialogue.outcome(result);
  }

  /** Then nothing can be said of what would have ended it. */
  boolean wasDoneSooner(Made usual) {
    return outcome().equals("SUCCEEDED") && took.toMillis() < usual.took.toMillis() * MOST_OF_IT;
  }

  /** The one of both that succeeded sooner. */
  Made orQuicker(Made other) {
    return other.outcome().equals("SUCCEEDED") && other.took.compareTo(took) < 0 ? other : this;
  }

  String doneSooner() {
    return "this time it was done in %d ms, before it could be ended".formatted(took.toMillis());
  }
}
