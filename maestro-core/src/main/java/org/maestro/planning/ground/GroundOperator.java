package org.maestro.planning.ground;

/**
 * An operator without parameters. All lists are ascending; what is added is not deleted.
 *
 * @param schema the number of the schema that it is of
 * @param arguments objects, in the order of the schema's parameters
 * @param needed facts that have to hold
 * @param bounds numbers of the bounds that have to be kept
 * @param changedSums numbers of sums
 * @param changes what is added to each of the changed sums
 * @param cost in units, at least 0
 */
public record GroundOperator(
    int schema,
    int[] arguments,
    int[] needed,
    int[] added,
    int[] deleted,
    int[] bounds,
    int[] changedSums,
    long[] changes,
    long cost) {}
