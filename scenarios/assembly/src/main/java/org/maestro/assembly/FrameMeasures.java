package org.maestro.assembly;

import java.util.Map;
import org.maestro.rats.protocol.StreamFrame;

/** Numbers that frames of one stream say, each frame after those before it. */
interface FrameMeasures {

  /**
   * @return by the words of the analyst's description
   * @throws IllegalArgumentException with a clause when the frame holds nothing that is measured
   *     here
   */
  Map<String, Double> of(StreamFrame frame);
}
