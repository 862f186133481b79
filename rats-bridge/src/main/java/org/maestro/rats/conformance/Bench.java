package org.maestro.rats.conformance;

import java.util.Map;
import org.maestro.rats.protocol.Topics;

/**
 * What every part of an examination works with.
 *
 * @param isOpen whether anybody may say anything on the site, also in the device's name
 */
record Bench(
    Examiner examiner,
    Dialogue dialogue,
    Topics topics,
    String member,
    boolean isOpen,
    Patience patience) {

  Map<String, Object> call(FeatureCall harmless) {
    return dialogue.call(harmless.feature(), harmless.parameters());
  }
}
