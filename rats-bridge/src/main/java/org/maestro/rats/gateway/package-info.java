/**
 * Foreign buses whose devices take part as members of the RATS bus: the lamps of a zigbee2mqtt
 * broker. Its messages flow in and members' calls flow out to it. What the members are called,
 * offer and report is told by whoever starts it; it knows no domain.
 */
@NullMarked
package org.maestro.rats.gateway;

import org.jspecify.annotations.NullMarked;
