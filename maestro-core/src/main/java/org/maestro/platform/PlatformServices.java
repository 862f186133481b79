package org.maestro.platform;

import java.util.function.BiFunction;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Device;
import org.maestro.planning.api.Planner;
import org.maestro.platform.failover.OtherNames;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.Clock;

/**
 * The services on which a platform runs.
 *
 * @param knowledge of the home whose devices get agents; closed with the platform
 * @param link to the bus
 * @param otherNames connects under another controller's name, for its calls
 * @param describedBy reads a description (first argument) that a member (second) sent
 */
public record PlatformServices(
    KnowledgeBase knowledge,
    Planner planner,
    RatsLink link,
    OtherNames otherNames,
    Clock clock,
    BiFunction<String, String, Device> describedBy) {}
