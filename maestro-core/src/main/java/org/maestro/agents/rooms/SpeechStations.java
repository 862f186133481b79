package org.maestro.agents.rooms;

import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The way of what is said in a room, told to the log at level debug: each station has the number
 * that figure 3 of the ADE paper gives it (A51). 1 word, 2 goal begun or taken back, 3 look, 4 nod,
 * 5 message, 6 goals, 9 answer, 10 speech; 8, the steps, stands in the goals' stories, and 7 is not
 * explained there.
 */
final class SpeechStations {
  private static final Logger LOG = LoggerFactory.getLogger(SpeechStations.class);

  static final int WORD = 1;
  static final int BEGUN = 2;
  static final int LOOK = 3;
  static final int NOD = 4;
  static final int MESSAGE = 5;
  static final int GOALS = 6;
  static final int ANSWER = 9;
  static final int SPEECH = 10;

  private final Clock clock;
  private final String agent;

  /**
   * @param agent whose room it is
   */
  SpeechStations(Clock clock, String agent) {
    this.clock = clock;
    this.agent = agent;
  }

  void at(int station, String what) {
    LOG.debug("{} {} {} {}", clock.now().toMillis(), agent, station, what);
  }
}
