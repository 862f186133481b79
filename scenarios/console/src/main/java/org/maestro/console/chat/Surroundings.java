package org.maestro.console.chat;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.maestro.console.access.Readership;
import org.maestro.dialogue.Utterance;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;

/**
 * Where conversations take place: each part as it is at the time. Any thread may ask.
 *
 * @param facts what is known
 * @param clock the time that clocks on the walls show
 * @param now simulated time since the platform's start
 * @param present the members that can be used
 * @param readership who may read what is private
 * @param seen told each answer, with what it answers and as whom, for faces to show it
 */
public record Surroundings(
    Supplier<Home> home,
    Supplier<Snapshot> facts,
    Supplier<Instant> clock,
    Supplier<Duration> now,
    Supplier<Collection<String>> present,
    Readership readership,
    BiConsumer<Utterance, ChatEvent> seen) {}
