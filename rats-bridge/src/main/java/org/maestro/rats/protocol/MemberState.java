package org.maestro.rats.protocol;

import java.util.List;

/**
 * What a member says of itself; retained.
 *
 * @param state z, the current abstract state
 * @param values facts in MAESTRO-SL: level, position, what it holds
 * @param running ids of the calls under way
 * @param queue ids of the calls that wait
 * @param disabled features that cannot run now
 */
public record MemberState(
    String member,
    String boot,
    String state,
    List<String> values,
    List<String> running,
    List<String> queue,
    List<String> disabled) {}
