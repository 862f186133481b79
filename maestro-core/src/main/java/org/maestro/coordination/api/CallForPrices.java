package org.maestro.coordination.api;

import java.util.List;
import java.util.Map;
import org.maestro.sl.Formula;

/**
 * A call for proposals: the question of a contract-net round.
 *
 * @param features names of the features in question, by member
 */
public record CallForPrices(String goalId, Formula goal, Map<String, List<String>> features) {}
