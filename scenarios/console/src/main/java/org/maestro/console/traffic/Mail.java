package org.maestro.console.traffic;

import java.time.Duration;
import java.time.Instant;
import org.maestro.platform.jade.SentMessage;

/**
 * A message between agents, as it was seen.
 *
 * @param conversation under which it is shown
 * @param message with as much of its content as is kept
 * @param characters of its content as it was
 * @param at wall time
 * @param since simulated time since the platform's clock began
 */
record Mail(String conversation, SentMessage message, int characters, Instant at, Duration since) {}
